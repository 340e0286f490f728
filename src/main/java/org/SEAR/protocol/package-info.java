/** What firmware and drivers share about serial lines. Uses nothing else. Any thread. */
package org.SEAR.protocol;
