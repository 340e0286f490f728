/**
 * Models of a project, loaded without trust. May use {@link org.SEAR.files}, {@link org.SEAR.geometry} and the grammar.
 * A loader serves one thread at a time.
 */
package org.SEAR.project.models;
