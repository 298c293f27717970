package rasterlab.exercises.child;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.file.Path;

/** The child's compiler in the process of the tests, where it soon is warm. */
public final class CompilerInProcess {
    private final Compiler compiler;

    /**
     * @param contractJar the only jar that a source may see
     */
    public CompilerInProcess(Path contractJar) {
        compiler = new Compiler(contractJar.toString());
    }

    /** The answer's status and payload. */
    public DataInputStream answer(String source) throws IOException {
        return new DataInputStream(new ByteArrayInputStream(compiler.compile(source)));
    }
}
