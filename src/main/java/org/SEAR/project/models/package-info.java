// SPDX-License-Identifier: Apache-2.0
/**
 * Loading of a project's untrusted models. Uses {@link org.SEAR.POJOs}, {@link org.SEAR.geometry} and
 * {@link org.SEAR.project.models.format} and their dependencies. A loader serves one thread at a time.
 */
package org.SEAR.project.models;
