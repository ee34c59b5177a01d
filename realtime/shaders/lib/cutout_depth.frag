// SPDX-License-Identifier: Apache-2.0
// For triangles with holes in passes that write depth alone: the executor discards where the holes are.

void main() {}
