package rasterlab.exercises.runner;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.exercises.runner.process.ChildJars;
import rasterlab.exercises.runner.process.JavaImages;
import rasterlab.exercises.runner.process.Launcher;
import rasterlab.exercises.runner.process.Programs;
import rasterlab.exercises.score.Message;

/**
 * The Java that children run on: images of the modules that each kind needs, or the running JDK.
 *
 * @param homes its home folder for each kind of children
 * @param images that made it; none where it is the running JDK
 * @param lacking why it is the running JDK; nothing where it is an image
 */
record ChildJava(Map<ChildKind, Path> homes, Optional<JavaImages> images, Message lacking) {
    ChildJava {
        homes = Map.copyOf(homes);
    }

    /** The running JDK, for that reason. */
    static ChildJava running(Message why) {
        Map<ChildKind, Path> homes = new EnumMap<>(ChildKind.class);
        for (ChildKind kind : ChildKind.values()) homes.put(kind, Programs.javaHome());
        return new ChildJava(homes, Optional.empty(), why);
    }

    /** The running JDK, where nobody asked for images. */
    static ChildJava running() {
        return running(Message.of("isolation.image-off"));
    }

    /** The running JDK, as long as images are made. */
    static ChildJava untilImages() {
        return running(Message.of("isolation.image-making"));
    }

    /** Whether images are wanted and can be made, but are not all there yet. */
    static boolean isToBeMade(JudgeSettings settings, Launcher launcher, ChildJars jars) {
        if (settings.images().isEmpty() || !JavaImages.canMake()) return false;
        JavaImages images = new JavaImages(settings.images().get(), launcher, jars);
        return !Stream.of(ChildKind.values())
                .allMatch(kind -> images.has(nameOf(kind), kind.modules()));
    }

    private static String nameOf(ChildKind kind) {
        return kind.name().toLowerCase(Locale.ROOT);
    }

    /** Images in the folder that the settings name; the running JDK where there can be none. */
    static ChildJava found(JudgeSettings settings, Launcher launcher, ChildJars jars) {
        if (settings.images().isEmpty()) return running();
        if (!JavaImages.canMake()) return running(Message.of("isolation.no-jlink"));
        JavaImages images = new JavaImages(settings.images().get(), launcher, jars);
        try {
            return of(images, jars);
        } catch (IOException e) {
            return running(failed(e.getMessage()));
        }
    }

    private static ChildJava of(JavaImages images, ChildJars jars) throws IOException {
        Map<ChildKind, Path> homes = new EnumMap<>(ChildKind.class);
        String harness = jars.harness().toString();
        String contract = jars.contract().toString();
        for (ChildKind kind : ChildKind.values()) {
            List<String> trial = kind.arguments(harness, contract, true);
            homes.put(kind, images.home(nameOf(kind), kind.modules(), trial));
        }
        return new ChildJava(homes, Optional.of(images), Message.NONE);
    }

    /**
     * The running JDK in place of images on which no child answers; they are made anew next time.
     */
    ChildJava without(String fault) {
        images.ifPresent(JavaImages::remove);
        return running(failed(fault));
    }

    private static Message failed(String fault) {
        return Message.of("isolation.image-fails", fault);
    }

    boolean isImage() {
        return images.isPresent();
    }

    Path home(ChildKind kind) {
        return homes.get(kind);
    }

    /** The program that starts a child of that kind. */
    String program(ChildKind kind) {
        return Programs.in(home(kind), "java").toString();
    }
}
