/**
 * The plan of a world: what it looks like from above, as outlines and as a picture. Uses {@link org.SEAR.plot} and {@link org.SEAR.scene}, and what
 * these use. No threads of its own.
 */
package org.SEAR.plan;
