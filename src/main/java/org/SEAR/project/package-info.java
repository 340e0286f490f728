// SPDX-License-Identifier: Apache-2.0
/**
 * The SEARproject folder on disk: its layout, reading and validation, writing of single objects, crash-safe
 * replacement, and the named beams. Uses {@link org.SEAR.project.models}, {@link org.SEAR.project.wiring} and
 * {@link org.SEAR.terrain} and their dependencies. Any thread; replacing a project locks its folder.
 */
package org.SEAR.project;
