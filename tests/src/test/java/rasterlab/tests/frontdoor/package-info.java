/**
 * The {@code ./lab} script and the README's commands, tried in a fresh copy of the sources whose
 * path has spaces in it.
 */
package rasterlab.tests.frontdoor;
