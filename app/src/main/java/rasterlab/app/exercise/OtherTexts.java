package rasterlab.app.exercise;

import java.io.IOException;
import java.util.List;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.outcome.Complaint;
import rasterlab.exercises.Exercise;

/** Replaces the text of an exercise by one that was written elsewhere, and loses neither. */
public record OtherTexts(ExerciseLabModel model) {
    /** Goes on with what another window wrote. */
    public void take(DraftFile.Other draft) {
        model.type(draft.text());
        tellOthers();
    }

    /**
     * Goes on with the text of a file, in its exercise, which may be none of the course's. The text
     * that there was is kept among the other drafts; where that cannot be, it stays, and the reason
     * is told.
     *
     * @param file that the text was read from, as the user named it
     */
    public void open(Exercise exercise, String text, String file) {
        model.state();
        model.exercises.put(exercise);
        model.choose(exercise.id());
        String before = model.state().source();
        if (before.equals(text)) return;
        boolean own = !before.equals(exercise.starter()) && !before.isBlank();
        try {
            if (own) model.sources.keepBeside(exercise);
        } catch (IOException | Complaint e) {
            model.tell(Notice.of("opened.not", file, String.valueOf(e.getMessage())));
            return;
        }
        model.type(text);
        tellOthers();
        List<DraftFile.Other> others = model.state().otherDrafts();
        boolean kept = own && others.stream().anyMatch(one -> one.text().equals(before));
        model.tell(Notice.of(kept ? "opened.kept" : "opened", file));
    }

    private void tellOthers() {
        Exercise shown = model.state().exercise();
        model.publish(model.changed().otherDrafts(model.sources.others(shown)));
    }
}
