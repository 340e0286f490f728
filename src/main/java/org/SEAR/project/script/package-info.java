/**
 * A project as the Python script that makes it, from the parameters of the grammar alone. Reads projects; no threads of its own.
 */
package org.SEAR.project.script;
