// SPDX-License-Identifier: Apache-2.0
/**
 * Lessons: copies them for pupils, runs pupils' scripts in separate processes, checks and marks them. May use
 * everything. The main thread, and one for each running script.
 */
package org.SEAR.cli.lessons;
