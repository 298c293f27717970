package rasterlab.exercises.runner;

import java.util.Optional;
import rasterlab.exercises.runner.scan.SourceWords;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Message;

/** Tells a source in Kotlin, whose compiler messages would help nobody. */
final class KotlinSource {
    private KotlinSource() {}

    /**
     * The first function written as in Kotlin, for a source that is no Java: there, "fun" before a
     * name could be a class.
     */
    static Optional<Diagnostic> in(String source) {
        SourceWords words = new SourceWords(source);
        while (words.next()) {
            if (!words.is("fun") || !Character.isJavaIdentifierStart(words.following())) continue;
            int line = words.line();
            int column = words.column();
            boolean named = words.next() && "(.<".indexOf(words.following()) >= 0;
            if (named)
                return Optional.of(new Diagnostic(line, column, Message.of("source.kotlin")));
        }
        return Optional.empty();
    }
}
