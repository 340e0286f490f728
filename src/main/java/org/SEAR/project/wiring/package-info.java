/** What the wires of boards are to the components of their robots. May use {@link org.SEAR.POJOs} and the problems of files. One thread at a time. */
package org.SEAR.project.wiring;
