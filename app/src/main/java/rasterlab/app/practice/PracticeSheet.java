package rasterlab.app.practice;

import rasterlab.exercises.Exercise;
import rasterlab.exercises.predicting.Question;
import rasterlab.exercises.predicting.Sheet;

/** Questions of one exercise that one seed draws. */
record PracticeSheet(Exercise exercise, Sheet sheet) {
    Question question(int at) {
        return sheet.questions().get(at);
    }

    int size() {
        return sheet.questions().size();
    }

    /** Whether both questions ask for steps of one walk. */
    boolean sameWalk(int one, int other) {
        return other < size()
                && question(one).input().equals(question(other).input())
                && question(one).before().size() < question(other).before().size();
    }
}
