package rasterlab.exercises.runner;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.List;
import rasterlab.contract.Pixels;
import rasterlab.exercises.child.Compiler;
import rasterlab.exercises.runner.scan.AllowList;
import rasterlab.exercises.runner.scan.ByteCodeCheck;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.GradingVerdict;

/**
 * Looks at a source of an exercise's folder as the judge looks at a student's, in this process:
 * compiles it and reads its classes, but runs nothing of it.
 */
public final class SourceCheck {
    private final Class<?> contract;
    private final Compiler compiler;

    /**
     * @param contract that the source has to implement
     */
    public SourceCheck(Class<?> contract) {
        this.contract = contract;
        this.compiler = new Compiler(place(contract));
    }

    private static String place(Class<?> contract) {
        try {
            return Path.of(contract.getProtectionDomain().getCodeSource().getLocation().toURI())
                    .toString();
        } catch (URISyntaxException e) {
            throw new AssertionError("a class lies somewhere", e);
        }
    }

    /** The faults of the source; none where a student could hand it in. */
    public List<Diagnostic> faults(String text) {
        String source = SourceText.withoutMark(text);
        var fault = SourceText.faultOf(source);
        if (fault.isPresent()) return List.of(fault.get().diagnostic());
        Compilation result = compiled(source);
        if (result.verdict() != GradingVerdict.OK) return result.errors();
        return new ByteCodeCheck(AllowList.of(contract))
                .check(result.classes(), contract.getName().replace('.', '/'), source)
                .refusals();
    }

    /** The compiler's errors in a source whose contract nobody knows. */
    public static List<Diagnostic> mistakes(String text) {
        String source = SourceText.withoutMark(text);
        return SourceText.faultOf(source)
                .map(fault -> List.of(fault.diagnostic()))
                .orElseGet(() -> new SourceCheck(Pixels.class).compiled(source).errors());
    }

    private Compilation compiled(String source) {
        try {
            byte[] answer = compiler.compile(source);
            DataInputStream in = new DataInputStream(new ByteArrayInputStream(answer));
            return Compilation.of(source, in.readByte(), in);
        } catch (IOException e) {
            throw new UncheckedIOException("reading from memory failed", e);
        }
    }
}
