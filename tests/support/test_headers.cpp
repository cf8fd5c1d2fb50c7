// SPDX-License-Identifier: BSD-3-Clause
// Gives the precompiled headers of tests a target of their own (cmake/NetloftTest.cmake).
int main() { return 0; }
