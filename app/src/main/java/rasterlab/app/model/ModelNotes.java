package rasterlab.app.model;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.obj.UpAxis;

/** A model that a lab opened, with what is told of it in one sentence. */
public record ModelNotes(Scene scene, String notes) {
    /** Notes that a stage has room for. */
    private static final int MOST = 3;

    /** A note that says one of these comes before those that say none, the first first. */
    private static final List<Pattern> WEIGHTS =
            Stream.of(
                            "left out|altogether|too small beside",
                            "texture|cannot be read|map_Kd",
                            "'d'|'Tr'",
                            "material|'Kd'|usemtl|mtllib",
                            "face|normal|colour|vertex|vertices")
                    .map(Pattern::compile)
                    .toList();

    /**
     * Reads a model with the axis up that models mostly have, y, and tells that.
     *
     * @throws rasterlab.app.outcome.Complaint as {@link ModelFile#read}
     */
    public static ModelNotes read(Path file) {
        return read(
                file,
                UpAxis.Y,
                List.of(
                        file
                                + ": y is taken to point up; the chooser of the axis turns the model"));
    }

    /**
     * Reads a model with an axis up that was chosen.
     *
     * @throws rasterlab.app.outcome.Complaint as {@link ModelFile#read}
     */
    public static ModelNotes read(Path file, UpAxis up) {
        return read(file, up, List.of());
    }

    private static ModelNotes read(Path file, UpAxis up, List<String> besides) {
        List<String> notes = new ArrayList<>();
        Consumer<String> keep = notes::add;
        Scene scene = ModelFile.read(file, up, keep);
        notes.sort(Comparator.comparing(ModelNotes::rank));
        List<String> told = new ArrayList<>(notes.subList(0, Math.min(MOST, notes.size())));
        if (notes.size() > MOST)
            told.add("further notes (%d) are told by ./lab render".formatted(notes.size() - MOST));
        told.addAll(besides);
        return new ModelNotes(scene, String.join("; besides, ", told));
    }

    /** The less, the more of the picture differs by what the note says; names do not count. */
    private static int rank(String note) {
        String said = note.substring(note.indexOf(": ") + 1);
        for (int rank = 0; rank < WEIGHTS.size(); rank++)
            if (WEIGHTS.get(rank).matcher(said).find()) return rank;
        return WEIGHTS.size();
    }
}
