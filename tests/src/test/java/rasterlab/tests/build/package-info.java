/**
 * Maven and Gradle describe the same modules: both are read from their files and compared.
 *
 * <p>Start with {@link rasterlab.tests.build.BuildEqualityTest}.
 */
package rasterlab.tests.build;
