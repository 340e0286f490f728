// SPDX-License-Identifier: Apache-2.0
/** Writes animated pictures of the tab. */
package org.SEAR.web.pictures;
