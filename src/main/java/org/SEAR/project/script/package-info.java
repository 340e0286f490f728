/**
 * A project as the Python script that makes it, from the parameters of the grammar alone. Uses {@link org.SEAR.project}, and what that uses. Reads
 * projects; no threads of its own.
 */
package org.SEAR.project.script;
