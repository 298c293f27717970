package rasterlab.app.cli;

import picocli.CommandLine.IVersionProvider;

/** What {@code ./lab --version} prints: ours and the Java it runs on. */
final class LabVersion implements IVersionProvider {
    @Override
    public String[] getVersion() {
        String packaged = Lab.class.getPackage().getImplementationVersion();
        String version = packaged == null ? "(built from source)" : packaged;
        return new String[] {
            "Rasterlab " + version,
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
