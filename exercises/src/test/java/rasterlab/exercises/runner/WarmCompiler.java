package rasterlab.exercises.runner;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import rasterlab.exercises.child.CompilerInProcess;
import rasterlab.exercises.runner.process.ChildJars;
import rasterlab.exercises.runner.process.TimeLimit;

/**
 * Compiles all sources of a test class in this process, as a child does: one that starts for each
 * source costs thirty times as much. Sources on which a compiler breaks need the child.
 */
final class WarmCompiler implements Compiling, AutoCloseable {
    private final ChildJars jars = ChildJars.assemble();
    private final CompilerInProcess compiler = new CompilerInProcess(jars.contract());

    @Override
    public Compilation compile(Children children, String source, TimeLimit limit) {
        try (DataInputStream answer = answer(source)) {
            return Compilation.of(source, answer.readByte(), answer);
        } catch (IOException unexpected) {
            throw new UncheckedIOException(unexpected);
        }
    }

    /** The answer's status and payload. */
    DataInputStream answer(String source) throws IOException {
        return compiler.answer(source);
    }

    @Override
    public void close() {
        jars.close();
    }
}
