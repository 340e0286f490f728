// SPDX-License-Identifier: Apache-2.0
/**
 * Work shared by several threads, with the same result as on one. Uses no other package of SEAR. One thread at a time
 * calls, and has all results when the call returns.
 */
package org.SEAR.parallel;
