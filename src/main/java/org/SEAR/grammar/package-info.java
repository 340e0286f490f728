// SPDX-License-Identifier: Apache-2.0
/**
 * Grammar of objects: annotations at the fields define the parameters' checks, file format and documentation. The
 * package knows no particular object. Uses {@link org.SEAR.protocol.lidar} and its dependencies. Any thread.
 */
package org.SEAR.grammar;
