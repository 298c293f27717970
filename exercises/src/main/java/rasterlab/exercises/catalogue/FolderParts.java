package rasterlab.exercises.catalogue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.Topics;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.StatementPicture;
import rasterlab.exercises.json.Faults;
import rasterlab.exercises.json.JsonFields;

/**
 * The parts of a folder that can be looked at by themselves, also where the exercise cannot be read
 * as a whole; each holds what could be read.
 *
 * @param titles of the exercise, by language
 * @param texts statements and hints, by their files' names
 * @param sources the starter and the model solution, by their files' names
 * @param contract that the sources have to implement; empty where the folder does not tell it
 */
public record FolderParts(
        Map<String, String> titles,
        Map<String, String> texts,
        List<StatementPicture> pictures,
        Map<String, String> sources,
        Optional<Class<?>> contract) {
    static final FolderParts NONE =
            new FolderParts(Map.of(), Map.of(), List.of(), Map.of(), Optional.empty());

    /**
     * Reads the parts once more, after the exercise.
     *
     * @param fields of {@code exercise.json}, where it could be read
     * @param faults takes what is wrong, which it may have already
     */
    static FolderParts of(ExerciseFolder folder, Optional<JsonFields> fields, Faults faults) {
        Map<String, String> statements = ExerciseReader.statements(folder, faults);
        Map<String, String> texts = new LinkedHashMap<>();
        statements.forEach((language, text) -> texts.put(StatementPictures.file(language), text));
        for (String language : List.of("en", "ru"))
            readIfThere(folder, HintReader.file(language), faults, texts);
        Faults told = new Faults();
        Optional<String> topic =
                fields.flatMap(all -> told.tried(() -> all.word("topic", Topics.names())));
        Optional<Class<?>> contract =
                fields.flatMap(all -> told.tried(() -> ExerciseReader.grading(all).contract()));
        var pictures = new StatementPictures(folder, topic).read(statements, faults);
        return new FolderParts(
                fields.flatMap(all -> ExerciseReader.titles(all, told)).orElse(Map.of()),
                texts,
                List.copyOf(pictures.values()),
                sources(folder, fields, faults),
                contract);
    }

    private static Map<String, String> sources(
            ExerciseFolder folder, Optional<JsonFields> fields, Faults faults) {
        Map<String, String> sources = new LinkedHashMap<>();
        if (fields.isPresent() && !isWritten(fields.get())) return sources;
        readIfThere(folder, "Starter.java", faults, sources);
        Faults told = new Faults();
        String model =
                fields.filter(all -> all.has("model"))
                        .flatMap(all -> told.tried(() -> all.text("model")))
                        .orElse("Model.java");
        readIfThere(folder, model, faults, sources);
        return sources;
    }

    private static boolean isWritten(JsonFields fields) {
        return ExerciseReader.form(fields, new Faults())
                .filter(TaskKind.WRITE.code()::equals)
                .isPresent();
    }

    private static void readIfThere(
            ExerciseFolder folder, String file, Faults faults, Map<String, String> read) {
        if (folder.has(file))
            faults.tried(() -> folder.text(file)).ifPresent(it -> read.put(file, it));
    }
}
