"""A small SVG writer: shapes, text and arrows on a light panel of its own, so that the picture reads the same on a
light and on a dark page. Colours are Okabe and Ito's, safe for colour-blind eyes; meaning never hangs on colour alone."""

from xml.sax.saxutils import escape

INK = "#1a1a1a"
GREY = "#6b6b6b"
LINE = "#b8b8b8"
PAPER = "#fcfcfa"
SHADE = "#ecece6"
BLUE = "#0072b2"
SKY = "#56b4e9"
GREEN = "#009e73"
ORANGE = "#d55e00"
AMBER = "#e69f00"
PINK = "#cc79a7"


def tint(colour, share):
    """The colour mixed with white: opaque, because not every renderer knows colours with alpha."""
    parts = (int(colour[i:i + 2], 16) for i in (1, 3, 5))
    return "#" + "".join(f"{round(255 - share * (255 - part)):02x}" for part in parts)


def number(value):
    text = f"{value:.1f}"
    return text[:-2] if text.endswith(".0") else text


class Picture:
    def __init__(self, width, height, title):
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
            f'font-family="Helvetica, Arial, sans-serif" font-size="16" fill="{INK}" role="img">',
            f"<title>{escape(title)}</title>",
            f'<rect width="{width}" height="{height}" rx="10" fill="{PAPER}"/>',
        ]

    def add(self, tag, content=None, **attributes):
        words = []
        for name, value in attributes.items():
            if value is not None:
                shown = number(value) if isinstance(value, (int, float)) else escape(str(value), {'"': "&quot;"})
                words.append(f'{name.rstrip("_").replace("_", "-")}="{shown}"')
        end = "/>" if content is None else f">{escape(content)}</{tag}>"
        self.parts.append(f"<{tag} {' '.join(words)}{end}")

    def line(self, x1, y1, x2, y2, stroke=INK, width=1.5, dash=None):
        self.add("line", x1=x1, y1=y1, x2=x2, y2=y2, stroke=stroke, stroke_width=width, stroke_dasharray=dash)

    def rect(self, x, y, w, h, fill="none", stroke=INK, width=1.5, rx=None, dash=None):
        self.add("rect", x=x, y=y, width=w, height=h, fill=fill, stroke=stroke, stroke_width=width, rx=rx,
                 stroke_dasharray=dash)

    def circle(self, x, y, r, fill="none", stroke=INK, width=1.5):
        self.add("circle", cx=x, cy=y, r=r, fill=fill, stroke=stroke, stroke_width=width)

    def text(self, x, y, content, size=16, fill=None, anchor="start", bold=False, mono=False):
        self.add("text", content, x=x, y=y, font_size=None if size == 16 else size, fill=fill,
                 text_anchor=None if anchor == "start" else anchor, font_weight="bold" if bold else None,
                 font_family="Menlo, Consolas, monospace" if mono else None)

    def polygon(self, points, fill):
        self.add("polygon", points=" ".join(f"{number(x)},{number(y)}" for x, y in points), fill=fill)

    def polyline(self, points, stroke, width=2.5, dash=None):
        self.add("polyline", points=" ".join(f"{number(x)},{number(y)}" for x, y in points), fill="none", stroke=stroke,
                 stroke_width=width, stroke_dasharray=dash, stroke_linejoin="round")

    def arrow(self, x1, y1, x2, y2, stroke=INK, width=2.0, dash=None, head=9.0):
        length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
        ux, uy = (x2 - x1) / length, (y2 - y1) / length
        bx, by = x2 - ux * head, y2 - uy * head
        self.line(x1, y1, bx, by, stroke, width, dash)
        side = 0.5 * head
        self.polygon([(x2, y2), (bx - uy * side, by + ux * side), (bx + uy * side, by - ux * side)], stroke)

    def finish(self):
        return "\n".join(self.parts) + "\n</svg>\n"


class Axes:
    """Maps data to the picture; log axes by a flag. Draws its own frame and ticks."""

    def __init__(self, picture, box, x_range, y_range, log_x=False, log_y=False):
        from math import log10
        self.picture, self.box = picture, box
        self.fx = log10 if log_x else float
        self.fy = log10 if log_y else float
        self.x_range = [self.fx(v) for v in x_range]
        self.y_range = [self.fy(v) for v in y_range]

    def x(self, value):
        left, _, width, _ = self.box
        return left + width * (self.fx(value) - self.x_range[0]) / (self.x_range[1] - self.x_range[0])

    def y(self, value):
        _, top, _, height = self.box
        return top + height * (self.y_range[1] - self.fy(value)) / (self.y_range[1] - self.y_range[0])

    def frame(self, x_ticks, y_ticks, x_label, y_label):
        left, top, width, height = self.box
        for value, label in y_ticks:
            self.picture.line(left, self.y(value), left + width, self.y(value), LINE, 1)
            self.picture.text(left - 8, self.y(value) + 5, label, 14, anchor="end")
        for value, label in x_ticks:
            self.picture.line(self.x(value), top + height, self.x(value), top + height + 6, INK, 1.5)
            self.picture.text(self.x(value), top + height + 22, label, 14, anchor="middle")
        self.picture.line(left, top + height, left + width, top + height)
        self.picture.line(left, top, left, top + height)
        self.picture.text(left + width / 2, top + height + 46, x_label, 15, anchor="middle")
        self.picture.text(left, top - 14, y_label, 15)

    def curve(self, points, stroke, width=2.5, dash=None):
        self.picture.polyline([(self.x(a), self.y(b)) for a, b in points], stroke, width, dash)
