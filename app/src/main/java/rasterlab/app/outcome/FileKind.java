package rasterlab.app.outcome;

import rasterlab.exercises.Grading;
import rasterlab.exercises.scene.SceneFile;

/** The kinds of files that are read, with the most bytes that each may have. */
public enum FileKind {
    SCENE("a scene", SceneFile.LONGEST),
    /** 10 million triangles with all they can have. */
    MODEL("a model", 1 << 30),
    MATERIALS("a material file", 16 << 20),
    /** A PNG of the largest size takes about half of it, however little it can be packed. */
    PICTURE("a picture", 512 << 20),
    SOURCE("a source", Grading.MOST_SOURCE_BYTES),
    /** A student's source as the window keeps it, finished or not. */
    DRAFT("a draft", 1 << 20),
    /** The outcome of a source, as the window keeps it, with pictures of all cases. */
    RESULT("a result", 16 << 20),
    /** The settings that the window keeps. */
    SETTINGS("a settings file", 4 << 20);

    private final String words;
    private final int most;

    FileKind(String words, int most) {
        this.words = words;
        this.most = most;
    }

    /** The kind's name with its article. */
    @Override
    public String toString() {
        return words;
    }

    /** The most bytes of such a file. */
    public int most() {
        return most;
    }
}
