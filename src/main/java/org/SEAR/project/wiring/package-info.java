/** What the wires of boards are to the components of their robots. Uses {@link org.SEAR.project.xml}, and what that uses. One thread at a time. */
package org.SEAR.project.wiring;
