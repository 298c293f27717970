package rasterlab.app.cli;

import picocli.CommandLine.IVersionProvider;
import rasterlab.engine.ProductVersion;

/** Prints for {@code ./lab --version} the version of Rasterlab and that of the Java it runs on. */
final class LabVersion implements IVersionProvider {
    @Override
    public String[] getVersion() {
        return new String[] {
            "Rasterlab " + ProductVersion.text(),
            "Java "
                    + System.getProperty("java.version")
                    + " ("
                    + System.getProperty("java.vendor")
                    + "), "
                    + System.getProperty("os.name")
                    + " "
                    + System.getProperty("os.arch")
        };
    }
}
