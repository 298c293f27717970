package rasterlab.exercises.child;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.Writer;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.ToolProvider;

/** Compiles one source against the contract, without annotation processing and without files. */
public final class Compiler {
    private final JavaCompiler javac = ToolProvider.getSystemJavaCompiler();
    private final String contractJar;

    /**
     * @param contractJar path of the only jar that the source may see
     */
    public Compiler(String contractJar) {
        this.contractJar = contractJar;
        if (javac == null) throw new IllegalStateException("this Java has no compiler: not a JDK");
    }

    /** The answer's status and payload, without the nonce. */
    public byte[] compile(String source) throws IOException {
        DiagnosticCollector<JavaFileObject> found = new DiagnosticCollector<>();
        MemoryFiles files =
                new MemoryFiles(
                        javac.getStandardFileManager(
                                found, Locale.ENGLISH, StandardCharsets.UTF_8));
        boolean done;
        try {
            done =
                    javac.getTask(
                                    Writer.nullWriter(),
                                    files,
                                    found,
                                    options(),
                                    null,
                                    List.of(MemoryFiles.source(source)))
                            .call();
        } catch (StackOverflowError | AssertionError | RuntimeException tooDeep) {
            return tooComplex();
        }
        if (done) return compiled(files.classes());
        List<Diagnostic<? extends JavaFileObject>> errors = new ArrayList<>();
        for (Diagnostic<? extends JavaFileObject> one : found.getDiagnostics())
            if (one.getKind() == Diagnostic.Kind.ERROR) errors.add(one);
        return errors.isEmpty() ? tooComplex() : failed(source, errors);
    }

    private List<String> options() {
        return List.of(
                "-proc:none",
                "--release",
                "17",
                "-encoding",
                "UTF-8",
                "-implicit:none",
                "-Xmaxerrs",
                "20",
                "-g",
                "-classpath",
                contractJar);
    }

    private static byte[] tooComplex() {
        return new byte[] {Wire.TOO_COMPLEX};
    }

    private static byte[] compiled(Map<String, byte[]> classes) throws IOException {
        if (classes.size() > Wire.MOST_CLASSES)
            return tooMuch(Wire.TOO_MANY_CLASSES, classes.size());
        long length = classes.values().stream().mapToLong(bytes -> bytes.length).sum();
        if (length > Wire.MOST_CLASS_BYTES) return tooMuch(Wire.CLASSES_TOO_LONG, length);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeByte(Wire.DONE);
        out.writeInt(classes.size());
        for (Map.Entry<String, byte[]> one : classes.entrySet()) {
            out.writeUTF(one.getKey());
            Frames.write(out, one.getValue());
        }
        return bytes.toByteArray();
    }

    private static byte[] tooMuch(int status, long amount) {
        return ByteBuffer.allocate(1 + Long.BYTES).put((byte) status).putLong(amount).array();
    }

    private static byte[] failed(String source, List<Diagnostic<? extends JavaFileObject>> errors)
            throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeByte(Wire.COMPILER_ERRORS);
        out.writeInt(errors.size());
        for (Diagnostic<? extends JavaFileObject> one : errors) {
            out.writeInt((int) Math.max(0, one.getLineNumber()));
            out.writeInt(column(source, one.getPosition()));
            out.writeUTF(Wire.cut(one.getMessage(Locale.ENGLISH)));
        }
        return bytes.toByteArray();
    }

    /**
     * The column from 1, in characters, as an editor counts; the compiler takes a tab for up to
     * eight.
     */
    private static int column(String source, long position) {
        if (position == Diagnostic.NOPOS) return 0;
        String before = source.substring(0, (int) Math.min(position, source.length()));
        return before.length() - Math.max(before.lastIndexOf('\n'), before.lastIndexOf('\r'));
    }
}
