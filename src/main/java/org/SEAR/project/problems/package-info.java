// SPDX-License-Identifier: Apache-2.0
/**
 * Problems of a project, each with file, line, field, value and legal values. Uses {@link org.SEAR.files}. Immutable,
 * except for the list.
 */
package org.SEAR.project.problems;
