/* A program as a robot with ROS 2 has it: `ros_robot DOMAIN (w|r) (scan|thing) TOPIC (reliable|best_effort)...` makes
   the writers and readers, says `there`, and keeps them until it is ended. */
#include <dds/dds.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "robot.h"

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const dds_entity_t participant = dds_create_participant((dds_domainid_t)atoi(argv[1]), NULL, NULL);
  if (participant < 0) return 2;
  for (int at = 2; at + 3 < argc; at += 4) {
    const dds_topic_descriptor_t* type =
        strcmp(argv[at + 1], "scan") == 0 ? &sensor_msgs_msg_dds__LaserScan__desc : &my_msgs_msg_dds__Thing__desc;
    dds_qos_t* qos = dds_create_qos();
    dds_qset_reliability(qos,
                         strcmp(argv[at + 3], "reliable") == 0 ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                         DDS_MSECS(100));
    const dds_entity_t topic = dds_create_topic(participant, type, argv[at + 2], NULL, NULL);
    const dds_entity_t made = argv[at][0] == 'w' ? dds_create_writer(participant, topic, qos, NULL)
                                                 : dds_create_reader(participant, topic, qos, NULL);
    dds_delete_qos(qos);
    if (topic < 0 || made < 0) return 2;
  }
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGTERM);
  sigprocmask(SIG_BLOCK, &ends, NULL);
  printf("there\n");
  fflush(stdout);
  int which = 0;
  sigwait(&ends, &which);
  dds_delete(participant);
  return 0;
}
