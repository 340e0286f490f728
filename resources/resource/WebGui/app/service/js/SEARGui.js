// SPDX-License-Identifier: Apache-2.0
// Panel of the SEAR service. MyRobotLab loads this script by its name. The panel's code is in modules loaded later.
angular.module('mrlapp.service.SEARGui', [])
    .controller('SEARGuiCtrl', ['$scope', '$timeout', '$interval', function($scope, $timeout, $interval) {
    import(new URL('service/js/sear/run/panel.js', document.baseURI)).then(panel => {
        if (!$scope.$$destroyed) {
            panel.open(this, $scope, $timeout, $interval)
        }
    }).catch(error => {
        $scope.failed = 'This panel did not load: ' + error.message + '. Reinstall SEAR, then reload this page'
    }).then(() => {
        $scope.$applyAsync()
    })
}])
