/** What is wrong with a project, each with file, line, field, value and what is legal. Uses nothing else. Immutable, but for the list. */
package org.SEAR.project.problems;
