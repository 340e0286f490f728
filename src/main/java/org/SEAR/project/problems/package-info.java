// SPDX-License-Identifier: Apache-2.0
/**
 * Problems of a project, each with file, line, field, value and legal values. Uses no other package of SEAR. Immutable,
 * except for the list.
 */
package org.SEAR.project.problems;
