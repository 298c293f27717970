package rasterlab.app.exercise;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import rasterlab.app.canvas.work.Background;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.server.Account;
import rasterlab.app.server.CourseServer;
import rasterlab.app.server.CourseServer.ServerTimeouts;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.predicting.HandedAnswers;
import rasterlab.exercises.predicting.SheetText;

/**
 * The text that an exercise is begun with: its own, or a sheet of questions, which is the server's
 * where there is an account.
 */
public record Beginning(Exercise exercise, Optional<Account> account, ServerTimeouts patience) {
    /** The text that needs no server; of a sheet another one at each call. */
    static String here(Exercise exercise) {
        return exercise.form() == TaskKind.PREDICT
                ? SheetText.open(exercise, SheetText.freshSeed())
                : exercise.starter();
    }

    /**
     * Gives the text at once, or what asks the server for it.
     *
     * @param begin takes what is to be done, and who is told why it failed
     */
    void give(
            Consumer<String> take,
            Consumer<Notice> tell,
            BiConsumer<Background.Task, Consumer<IOException>> begin) {
        if (exercise.form() != TaskKind.PREDICT || account.isEmpty()) take.accept(here(exercise));
        else begin.accept(asked(take), refused(tell));
    }

    /**
     * The sheet to go on with: as it is so far or, where none of it is answered, the server's.
     * Takes long.
     *
     * @throws UnreadableSheet if the text is no sheet
     */
    public HandedAnswers sheet(String text) throws IOException, InterruptedException {
        HandedAnswers begun = UnreadableSheet.read(exercise, text);
        boolean untouched =
                begun.sheet().questions().stream()
                        .allMatch(one -> one.isOpen(begun.answers().get(one.number() - 1)));
        return untouched && account.isPresent() ? UnreadableSheet.read(exercise, asked()) : begun;
    }

    /** Asks the server for the sheet of the next attempt. */
    private Background.Task asked(Consumer<String> take) {
        return tell -> {
            String text = asked();
            return () -> take.accept(text);
        };
    }

    private String asked() throws IOException, InterruptedException {
        Account holder = account.orElseThrow();
        byte[] sheet =
                new CourseServer(holder.server(), patience)
                        .get("/api/v1/exercises/" + exercise.id() + "/starter", holder.token());
        return new String(sheet, StandardCharsets.UTF_8);
    }

    /** Tells why the server did not give it, or why a sheet cannot be read. */
    public Consumer<IOException> refused(Consumer<Notice> tell) {
        return failure ->
                tell.accept(
                        failure instanceof UnreadableSheet sheet
                                ? sheet.notice()
                                : ServerNotices.of(account.orElseThrow().server(), failure));
    }
}
