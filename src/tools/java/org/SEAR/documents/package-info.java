// SPDX-License-Identifier: Apache-2.0
/** Writes pages and type hints from the javadoc of the services. */
package org.SEAR.documents;
