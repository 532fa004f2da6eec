// Failure is data: a stage that meets one sets its bit and counts it.
layout(std430, binding = SLOT_STATUS) buffer StatusBlock { Status status; };
