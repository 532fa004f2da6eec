"""The part of JSON Schema (draft 2020-12) that assets/scenes/scene.schema.json uses, checked. Standard library only."""
import math

# Keywords that say nothing about validity; unit and setting are ours.
ANNOTATIONS = {"$schema", "$comment", "$defs", "title", "description", "default", "unit", "setting"}
CHECKED = {"$ref", "type", "enum", "const", "minimum", "maximum", "minLength", "minItems", "maxItems", "items",
           "properties", "required", "additionalProperties", "allOf", "anyOf", "not", "if", "then", "else"}


def resolve(root, schema):
    """The schema itself, behind references."""
    while isinstance(schema, dict) and "$ref" in schema:
        node = root
        for part in schema["$ref"].removeprefix("#/").split("/"):
            node = node[part]
        schema = node
    return schema


def subschemas(schema):
    """The schemas directly inside one."""
    for key in ("items", "not", "if", "then", "else"):
        if key in schema:
            yield schema[key]
    for key in ("properties", "$defs"):
        yield from schema.get(key, {}).values()
    for key in ("allOf", "anyOf"):
        yield from schema.get(key, ())


def unknown_keywords(schema):
    """Keywords, anywhere inside, that valid() would leave out."""
    if isinstance(schema, bool):
        return set()
    found = set(schema) - ANNOTATIONS - CHECKED
    return found.union(*(unknown_keywords(inner) for inner in subschemas(schema)))


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def has_type(value, name):
    if name == "integer":
        return is_number(value) and (isinstance(value, int) or (math.isfinite(value) and value.is_integer()))
    if name == "number":
        return is_number(value)
    return isinstance(value, {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None)}[name])


def same(a, b):
    """Equality of JSON: true is not 1."""
    return isinstance(a, bool) == isinstance(b, bool) and a == b


def valid_alone(schema, value):
    if "type" in schema and not has_type(value, schema["type"]):
        return False
    if "enum" in schema and not any(same(value, choice) for choice in schema["enum"]):
        return False
    if "const" in schema and not same(value, schema["const"]):
        return False
    if is_number(value):
        return schema.get("minimum", -math.inf) <= value <= schema.get("maximum", math.inf)
    if isinstance(value, str):
        return len(value) >= schema.get("minLength", 0)
    if isinstance(value, list):
        return schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", math.inf)
    return True


def valid_inside(root, schema, value):
    if isinstance(value, list):
        return all(valid(root, schema.get("items", True), element) for element in value)
    if not isinstance(value, dict):
        return True
    known = schema.get("properties", {})
    return (set(schema.get("required", ())) <= set(value) and
            all(valid(root, known[key] if key in known else schema.get("additionalProperties", True), inner)
                for key, inner in value.items()))


def valid_in_parts(root, schema, value):
    if not all(valid(root, part, value) for part in schema.get("allOf", ())):
        return False
    if "anyOf" in schema and not any(valid(root, part, value) for part in schema["anyOf"]):
        return False
    if "not" in schema and valid(root, schema["not"], value):
        return False
    if "if" in schema:
        branch = "then" if valid(root, schema["if"], value) else "else"
        return valid(root, schema.get(branch, True), value)
    return True


def valid(root, schema, value):
    """Whether `value` is an instance of `schema`, whose references start at `root`."""
    if isinstance(schema, bool):
        return schema
    if "$ref" in schema and not valid(root, resolve(root, schema), value):
        return False
    return valid_alone(schema, value) and valid_inside(root, schema, value) and valid_in_parts(root, schema, value)
