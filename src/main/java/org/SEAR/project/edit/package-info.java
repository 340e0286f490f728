// SPDX-License-Identifier: Apache-2.0
/**
 * Edits of a project as values. Each edit is checked as its files would be, written immediately, and can be undone.
 * Uses {@link org.SEAR.project} and its dependencies. Any thread; edits of one project wait for each other.
 */
package org.SEAR.project.edit;
