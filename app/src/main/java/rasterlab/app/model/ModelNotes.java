package rasterlab.app.model;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.obj.UpAxis;

/** A model that a lab opened, with what is told of it in one sentence. */
public record ModelNotes(Scene scene, String told) {
    /** Notes that a stage has room for. */
    private static final int MOST = 3;

    /**
     * Reads a model with the axis up that models mostly have, y.
     *
     * @throws rasterlab.app.outcome.Complaint as {@link ModelFile#read}
     */
    public static ModelNotes read(Path file) {
        List<String> notes = new ArrayList<>();
        Consumer<String> keep = notes::add;
        Scene scene = ModelFile.read(file, UpAxis.Y, keep);
        List<String> told = new ArrayList<>(notes.subList(0, Math.min(MOST, notes.size())));
        if (notes.size() > MOST)
            told.add("further notes (%d) are told by ./lab render".formatted(notes.size() - MOST));
        told.add(file + ": y is taken to point up; ./lab render --up z draws it with z up");
        return new ModelNotes(scene, String.join("; besides, ", told));
    }
}
