/** The root of Javino: what all of its packages throw. */
package javino;
