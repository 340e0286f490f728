// SPDX-License-Identifier: Apache-2.0
/** Reads the dependencies of packages from class files and draws them. */
package org.SEAR.architecture;
