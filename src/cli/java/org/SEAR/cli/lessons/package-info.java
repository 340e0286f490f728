/**
 * Lessons: handing them out, running pupils' scripts in processes of their own, checking and marking what they did. May use everything. The main
 * thread, and one for each script that runs.
 */
package org.SEAR.cli.lessons;
