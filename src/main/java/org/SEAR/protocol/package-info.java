/** What firmware and drivers share about serial lines. Uses no other package of SEAR. Any thread. */
package org.SEAR.protocol;
