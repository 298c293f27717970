package rasterlab.exercises.runner.process;

import java.io.IOException;
import java.nio.file.Path;

/** A process that has children's jars and waits to be killed. */
final class LivingJars {
    private LivingJars() {}

    /**
     * @param args where the folder is made
     */
    public static void main(String[] args) throws IOException {
        System.out.println("ready: " + ChildJars.assemble(Path.of(args[0])).folder());
        System.in.read();
    }
}
