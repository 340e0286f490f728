/**
 * Edits of a project as values: each is checked as its files would be, written at once, and can be undone. Uses {@link org.SEAR.project}, and what
 * that uses. Any thread; edits of one project wait for each other.
 */
package org.SEAR.project.edit;
