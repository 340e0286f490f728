// SPDX-License-Identifier: Apache-2.0
/**
 * XML files of single objects: strict reading and stable writing by the tables of the object grammar. Uses
 * {@link org.SEAR.POJOs} and {@link org.SEAR.project.problems} and their dependencies. The package knows no folders.
 * Any thread.
 */
package org.SEAR.project.xml;
