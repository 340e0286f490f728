/**
 * Work shared by several threads, with the same result as on one. Independent of the rest of SEAR. One thread at a time
 * calls, and has all results when the call returns.
 */
package org.SEAR.parallel;
