// SPDX-License-Identifier: Apache-2.0
/** Properties of serial lines shared by firmware and drivers. Uses no other package of SEAR. Any thread. */
package org.SEAR.protocol;
