/**
 * Pictures and models of a project: finding them, loading models without trust. May use {@link org.SEAR.project.problems} and the grammar.
 * A loader serves one thread at a time.
 */
package org.SEAR.project.models;
