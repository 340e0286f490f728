// SPDX-License-Identifier: Apache-2.0
/**
 * Contests: one simulation in which each script drives its own robot, a referee, and the scoreboard. May use
 * everything. The main thread, one for each script and one for the referee; only one of them runs at a time.
 */
package org.SEAR.cli.contests;
