package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import org.junit.jupiter.api.Test;
import rasterlab.contract.MatrixFormula;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.score.Answer;

/** Each message of a child is an answer, a finding in words of ours, or the child's loss. */
class StudentMethodProxyTest {
    /** Writes what a child sent. */
    private interface Sent {
        void to(DataOutputStream out) throws IOException;
    }

    private static StudentMethodProxy asked(Sent sent) throws IOException {
        var bytes = new ByteArrayOutputStream();
        sent.to(new DataOutputStream(bytes));
        return new StudentMethodProxy(
                ContractCalls.of(MatrixFormula.class),
                (call, arguments) ->
                        new StudentMethodProxy.CallReply(Wire.DONE, bytes.toByteArray(), ""));
    }

    private static double[][] rows(StudentMethodProxy asked) {
        return ((MatrixFormula) asked.method()).rows("ID3D", 1, 2);
    }

    /** One row of one number, and which held arrays the matrix and its row are. */
    private static Sent oneRow(int matrix, int row) {
        return out -> {
            out.writeBoolean(true);
            out.writeInt(1);
            out.writeBoolean(true);
            out.writeInt(1);
            out.writeDouble(7);
            out.writeInt(matrix);
            out.writeInt(row);
            out.writeBoolean(false);
        };
    }

    @Test
    void anAnswerArrivesAsItIs() throws IOException {
        assertEquals(7, rows(asked(oneRow(0, 0)))[0][0]);
    }

    @Test
    void nullInTheMiddleOfAnAnswerIsTold() throws IOException {
        StudentMethodProxy asked =
                asked(
                        out -> {
                            out.writeBoolean(true);
                            out.writeInt(2);
                            out.writeBoolean(false);
                            out.writeBoolean(true);
                            out.writeInt(0);
                            out.writeInt(0);
                            out.writeInt(0);
                            out.writeBoolean(false);
                        });
        assertThrows(StudentMethodProxy.Unanswered.class, () -> rows(asked));
        Answer answer = asked.ended().orElseThrow();
        assertEquals(Answer.CallEnding.UNUSABLE, answer.ending());
        assertEquals("there is null within what it returns", answer.explanation().in("en"));
        assertEquals("внутри возвращённого значения есть null", answer.explanation().in("ru"));
    }

    @Test
    void anArrayThatNobodyHoldsIsNoAnswer() throws IOException {
        for (int number : new int[] {-1, 2, Integer.MAX_VALUE})
            assertLost(oneRow(0, number), "array " + number + " of 1");
    }

    /** The parameters are two numbers, the row is one; a matrix is no row. */
    @Test
    void aHeldArrayOfAnotherShapeIsNoAnswer() throws IOException {
        assertLost(oneRow(0, 1), "array 1 is another");
        assertLost(oneRow(1, 0), "array 1 is another");
    }

    @Test
    void anAnswerThatEndsInItsMiddleIsNone() throws IOException {
        assertLost(
                out -> {
                    out.writeBoolean(true);
                    out.writeInt(1_000_000);
                },
                "1000000 items announced, 0 bytes left");
    }

    private static void assertLost(Sent sent, String said) throws IOException {
        StudentMethodProxy asked = asked(sent);
        Throwable cause =
                assertThrows(StudentMethodProxy.Unanswered.class, () -> rows(asked)).getCause();
        ChildLost lost = (ChildLost) cause;
        assertEquals(ChildLost.LossReason.PROTOCOL, lost.reason());
        assertEquals(true, lost.getMessage().contains(said), lost::getMessage);
    }
}
