package rasterlab.tests.frontdoor;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;

/**
 * The sources as somebody gets them who has just cloned them, built once by {@code ./lab} itself
 * for all tests that ask for it.
 *
 * @param folder where {@code lab} lies; has spaces in its path
 * @param firstRun the call that built it
 */
record FreshCopy(Path folder, ChildProcess firstRun) implements AutoCloseable {
    private static final Set<String> LEFT_OUT =
            Set.of("target", "build", ".git", ".gradle", ".kotlin", ".idea");

    static FreshCopy build() throws IOException {
        var folder = Files.createTempDirectory("rasterlab fresh copy ").resolve("a folder");
        copySources(folder);
        var copy = new FreshCopy(folder, null);
        return new FreshCopy(folder, copy.lab(folder, Duration.ofMinutes(15), "methods"));
    }

    /** Runs {@code ./lab} with arguments from a working folder. */
    ChildProcess lab(Path from, Duration limit, String... arguments) {
        var command = new ArrayList<>(List.of(folder.resolve("lab").toString()));
        command.addAll(List.of(arguments));
        return ChildProcess.run(from, withJava(), limit, command);
    }

    /** The JDK that runs the tests runs the copy too. */
    static Map<String, String> withJava() {
        return Map.of("JAVA_HOME", System.getProperty("java.home"));
    }

    static void copySources(Path target) throws IOException {
        var root = Repository.root();
        Files.walkFileTree(
                root,
                new SimpleFileVisitor<>() {
                    @Override
                    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes a)
                            throws IOException {
                        if (LEFT_OUT.contains(folder.getFileName().toString())
                                && !folder.equals(root)) return FileVisitResult.SKIP_SUBTREE;
                        Files.createDirectories(target.resolve(root.relativize(folder).toString()));
                        return FileVisitResult.CONTINUE;
                    }

                    @Override
                    public FileVisitResult visitFile(Path file, BasicFileAttributes a)
                            throws IOException {
                        var copy = target.resolve(root.relativize(file).toString());
                        Files.copy(file, copy, StandardCopyOption.COPY_ATTRIBUTES);
                        return FileVisitResult.CONTINUE;
                    }
                });
    }

    @Override
    public void close() throws IOException {
        Files.walkFileTree(
                folder.getParent(),
                new SimpleFileVisitor<>() {
                    @Override
                    public FileVisitResult visitFile(Path file, BasicFileAttributes a)
                            throws IOException {
                        Files.delete(file);
                        return FileVisitResult.CONTINUE;
                    }

                    @Override
                    public FileVisitResult postVisitDirectory(Path visited, IOException failure)
                            throws IOException {
                        if (failure != null) throw failure;
                        Files.delete(visited);
                        return FileVisitResult.CONTINUE;
                    }
                });
    }

    /** Gives tests the one copy; it is removed when all tests are done. */
    static final class Provider implements ParameterResolver {
        private static final ExtensionContext.Namespace NAMESPACE =
                ExtensionContext.Namespace.create(FreshCopy.class);

        @Override
        public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
            return parameter.getParameter().getType() == FreshCopy.class;
        }

        @Override
        public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
            return context.getRoot()
                    .getStore(NAMESPACE)
                    .getOrComputeIfAbsent(FreshCopy.class, type -> builtCopy());
        }

        private static FreshCopy builtCopy() {
            try {
                return build();
            } catch (IOException e) {
                throw new java.io.UncheckedIOException(e);
            }
        }
    }
}
