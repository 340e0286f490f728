/** What is wrong with a project, each with file, line, field, value and what is legal. Uses no other package of SEAR. Immutable, but for the list. */
package org.SEAR.project.problems;
